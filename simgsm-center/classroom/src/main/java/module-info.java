/** Demo, class and lessons; they start the programs and read their consoles. */
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
