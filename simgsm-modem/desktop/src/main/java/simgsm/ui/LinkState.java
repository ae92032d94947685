package simgsm.ui;

import java.util.Locale;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

/** The state of the link to the centre, with its mark, colour and word. */
public enum LinkState {
    /** Registered; for the centre: listening. */
    UP(StatusMark.DISC, Ink.GOOD),
    /** No centre found yet. */
    SEARCHING(StatusMark.HALF_DISC, Ink.WARNING),
    /** The SIM is locked, or an emergency call is under way without registration. */
    EMERGENCY_ONLY(StatusMark.DIAMOND, Ink.WARNING),
    /** Rejected by the network. */
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

    /** The state in words, as "in service". */
    public String word(Locale language) {
        return DesktopTexts.in(language).of("link." + name().toLowerCase(Locale.ROOT));
    }

    public Ink ink() {
        return ink;
    }
}
