package simgsm.center.ui.ladder;

import simgsm.center.msc.LadderEntry;
import simgsm.draw.Ink;

/** The protocol of a message, by its discriminator; each has a tag and a colour. */
enum Protocol {
    CALL_CONTROL("CC", Ink.ACCENT),
    MOBILITY_MANAGEMENT("MM", Ink.GOOD),
    SHORT_MESSAGES("SMS", Ink.WARNING),
    /** Outside a call; within one call control carries them. */
    SUPPLEMENTARY_SERVICES("SS", Ink.TEXT),
    RADIO_RESOURCE("RR", Ink.QUIET),
    /** Paging, cell broadcast, and messages between a tower and its controller. */
    COMMON_CHANNEL("RSL", Ink.QUIET);

    private static final int DISCRIMINATOR_MASK = 0x0f;

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
            case 0xb:
                return SUPPLEMENTARY_SERVICES;
            // radio link layer, dedicated and common channels, transceiver, ip.access: no layer 3 protocol has these
            // numbers
            case 0x2, 0x8, 0xc, 0x0, 0xe:
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
