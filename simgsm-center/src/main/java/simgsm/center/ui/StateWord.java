package simgsm.center.ui;

import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

/** A state in a table: shape, colour and word. */
record StateWord(StatusMark mark, Ink ink, String word) {
    /** Used by assistive technology and for sorting. */
    @Override
    public String toString() {
        return word;
    }
}
