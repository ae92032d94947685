/** Lessons: their files, the conditions of their steps, and their texts. */
module simgsm.lesson {
    requires transitive simgsm.console;
    requires simgsm.base;

    exports simgsm.lesson;
}
