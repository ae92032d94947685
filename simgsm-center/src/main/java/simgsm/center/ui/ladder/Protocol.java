package simgsm.center.ui.ladder;

import simgsm.center.msc.LadderEntry;
import simgsm.draw.Ink;

/** The protocol of a message, by its discriminator; each has a tag and a colour. */
enum Protocol {
    CALL_CONTROL("CC", Ink.ACCENT),
    MOBILITY_MANAGEMENT("MM", Ink.GOOD),
    SHORT_MESSAGES("SMS", Ink.WARNING),
    RADIO_RESOURCE("RR", Ink.QUIET),
    /** Paging and cell broadcast. */
    COMMON_CHANNEL("RSL", Ink.QUIET);

    private static final int DISCRIMINATOR_MASK = 0x0f;
    private static final int RSL_COMMON_CHANNEL = 0x0c;

    private final String tag;
    private final Ink ink;

    Protocol(String tag, Ink ink) {
        this.tag = tag;
        this.ink = ink;
    }

    static Protocol of(LadderEntry entry) {
        if (entry.octets().length() == 0) {
            return RADIO_RESOURCE;
        }
        switch (entry.octets().octet(0) & DISCRIMINATOR_MASK) {
            case 3:
                return CALL_CONTROL;
            case 5:
                return MOBILITY_MANAGEMENT;
            case 9:
                return SHORT_MESSAGES;
            case RSL_COMMON_CHANNEL:
                return COMMON_CHANNEL;
            default:
                return RADIO_RESOURCE;
        }
    }

    String tag() {
        return tag;
    }

    Ink ink() {
        return ink;
    }
}
