/** What starts the programs and reads their consoles: demo, class and lessons. */
module simgsm.classroom {
    requires simgsm.center;
    requires simgsm.lesson;
    requires simgsm.air;
    requires simgsm.sound;
    requires simgsm.console;
    requires simgsm.desktop;
    requires simgsm.web;

    provides simgsm.center.CenterLauncher with
            simgsm.classroom.SuiteLauncher;
}
