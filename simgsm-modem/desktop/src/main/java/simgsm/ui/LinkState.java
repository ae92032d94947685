package simgsm.ui;

import java.util.Locale;
import simgsm.ui.Theme.Ink;

/** The link to the centre, as every window's lamp shows it. */
public enum LinkState {
    /** Registered, or with the centre: listening. */
    UP(Mark.DISC, Ink.GOOD),
    /** No centre yet; trying. */
    SEARCHING(Mark.HALF_DISC, Ink.WARNING),
    /** The network refuses. */
    REFUSED(Mark.SLASHED_RING, Ink.DANGER),
    /** Switched off. */
    OFF(Mark.RING, Ink.QUIET);

    private final Mark mark;
    private final Ink ink;

    LinkState(Mark mark, Ink ink) {
        this.mark = mark;
        this.ink = ink;
    }

    public Mark mark() {
        return mark;
    }

    /** As in "in service". */
    public String word(Locale language) {
        return DesktopTexts.in(language).of("link." + name().toLowerCase(Locale.ROOT));
    }

    public Ink ink() {
        return ink;
    }
}
