find_package(nlohmann_json 3.11 REQUIRED)
cambrian_wrap(json nlohmann_json::nlohmann_json)
