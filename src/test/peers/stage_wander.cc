// The wander rule of the speed comparison on Stage: stage_wander WORLD ROBOTS SECONDS
// Prints "ran robots= simulated= cpu=". The rule is SimRobot's own (simrobot.process.Wander).
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <unistd.h>

#include "stage.hh"

struct Wanderer {
    Stg::ModelPosition *body;
    Stg::ModelRanger *sonars;
    bool left;
    int avoiding;
};

static int decide(Stg::Model *, void *argument) {
    Wanderer *robot = static_cast<Wanderer *>(argument);
    const std::vector<Stg::ModelRanger::Sensor> &sensors = robot->sonars->GetSensors();
    double nearest = 5;
    for (int i = 1; i <= 6; i++) {
        if (!sensors[i].ranges.empty()) {
            nearest = std::min(nearest, sensors[i].ranges[0]);
        }
    }
    if (robot->avoiding == 0 && (nearest < 0.5 || robot->body->Stalled())) {
        robot->avoiding = 10;
    }
    if (robot->avoiding > 0) {
        robot->avoiding--;
        robot->body->SetSpeed(0, 0, (robot->left ? 50 : -50) * M_PI / 180);
    } else {
        robot->body->SetSpeed(0.4, 0, 0);
    }
    return 0;
}

int main(int argc, char *argv[]) {
    Stg::Init(&argc, &argv);
    Stg::World world("wander");
    world.Load(argv[1]);
    int robots = atoi(argv[2]);
    for (int i = 0; i < robots; i++) {
        std::string name = "r" + std::to_string(i);
        Wanderer *robot = new Wanderer();
        robot->body = dynamic_cast<Stg::ModelPosition *>(world.GetModel(name));
        robot->sonars = dynamic_cast<Stg::ModelRanger *>(world.GetModel(name + ".ranger:0"));
        if (!robot->body || !robot->sonars) {
            fprintf(stderr, "no robot %s with sonars in %s\n", name.c_str(), argv[1]);
            return 1;
        }
        robot->left = i % 2 == 0;
        robot->avoiding = 0;
        robot->sonars->AddCallback(Stg::Model::CB_UPDATE, decide, robot);
        robot->body->Subscribe();
        robot->sonars->Subscribe();
    }
    world.Start();
    double seconds = atof(argv[3]);
    while (world.SimTimeNow() < seconds * 1e6) {
        world.Update();
    }
    printf("ran robots=%d simulated=%s cpu=%.2f\n", robots, argv[3], (double)clock() / CLOCKS_PER_SEC);
    fflush(stdout);
    _exit(0);  // Stage's own end of a world with robots crashes
}
