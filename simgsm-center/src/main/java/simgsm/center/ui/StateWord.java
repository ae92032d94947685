package simgsm.center.ui;

import simgsm.ui.Mark;
import simgsm.ui.Theme.Ink;

/** A state as a table shows it: shape and word, the colour only helps. */
record StateWord(Mark mark, Ink ink, String word) {
    /** For assistive technology and for sorting. */
    @Override
    public String toString() {
        return word;
    }
}
