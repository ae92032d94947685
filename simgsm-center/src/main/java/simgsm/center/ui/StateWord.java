package simgsm.center.ui;

import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

/** A state as a table shows it: shape and word, the colour only helps. */
record StateWord(StatusMark mark, Ink ink, String word) {
    /** For assistive technology and for sorting. */
    @Override
    public String toString() {
        return word;
    }
}
