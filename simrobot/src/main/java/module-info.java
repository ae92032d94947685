/** SimRobot: worlds, the Pioneer, the simulation, and on top of them the GSM modem (M2) and VeriCommand. */
module simrobot {
    requires transitive simgsm.modem;
    requires transitive vericommand;

    exports simrobot.world;
    exports simrobot.robot;
    exports simrobot.simulation;
    exports simrobot.control;
    exports simrobot.p2os;
}
