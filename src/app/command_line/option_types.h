#pragma once

// The types of options as the help shows them. Completion reads file name endings from these words:
// FILE and an ending, or several with '|' between.

namespace cambrian::option_type {

inline constexpr const char* kFile = "FILE";
inline constexpr const char* kFolder = "FOLDER";
inline constexpr const char* kCreature = "FILE.creature.json|FILE.card.png|FILE.html";
inline constexpr const char* kSettings = "FILE.toml";
inline constexpr const char* kExperiment = "FILE.cambrian";
inline constexpr const char* kCreatureOrExperiment =
    "FILE.creature.json|FILE.card.png|FILE.html|FILE.cambrian";
inline constexpr const char* kAnyOfOurs =
    "FILE.creature.json|FILE.card.png|FILE.html|FILE.toml|FILE.cambrian";
inline constexpr const char* kTable = "FILE.csv";
inline constexpr const char* kPage = "FILE.html";
inline constexpr const char* kChallengeOrBoard = "FILE.challenge.toml|FILE.md|FILE.html";
inline constexpr const char* kPicture = "FILE.png";
inline constexpr const char* kClip = "FILE.mp4|FILE.gif|FILE.apng";
inline constexpr const char* kDrawing = "FILE.png|FILE.mp4|FILE.gif|FILE.apng|FILE.html";

}  // namespace cambrian::option_type
