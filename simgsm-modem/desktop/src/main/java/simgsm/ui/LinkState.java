package simgsm.ui;

import java.util.Locale;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

/** The link to the centre, as every window's lamp shows it. */
public enum LinkState {
    /** Registered, or with the centre: listening. */
    UP(StatusMark.DISC, Ink.GOOD),
    /** No centre yet; trying. */
    SEARCHING(StatusMark.HALF_DISC, Ink.WARNING),
    /** The network refuses. */
    REFUSED(StatusMark.SLASHED_RING, Ink.DANGER),
    /** Switched off. */
    OFF(StatusMark.RING, Ink.QUIET);

    private final StatusMark mark;
    private final Ink ink;

    LinkState(StatusMark mark, Ink ink) {
        this.mark = mark;
        this.ink = ink;
    }

    public StatusMark mark() {
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
