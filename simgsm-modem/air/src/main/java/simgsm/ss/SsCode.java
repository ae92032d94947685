package simgsm.ss;

import java.util.List;
import java.util.Optional;
import simgsm.air.Coded;

/** Supplementary services in use: SS-Code (TS 29.002, 17.7.5) and the typed code (TS 22.030, annex B). */
public enum SsCode implements Coded {
    ALL_FORWARDING(0x20, "002"),
    FORWARDING_UNCONDITIONAL(0x21, "21"),
    ALL_CONDITIONAL_FORWARDING(0x28, "004"),
    FORWARDING_ON_BUSY(0x29, "67"),
    FORWARDING_ON_NO_REPLY(0x2a, "61"),
    FORWARDING_ON_NOT_REACHABLE(0x2b, "62"),
    /** CLIP: the caller's number is shown. */
    CALLING_LINE_PRESENTATION(0x11, "30"),
    /** CLIR: one's own number is hidden from the called party. */
    CALLING_LINE_RESTRICTION(0x12, "31"),
    /** COLP: the answering number is shown to the caller. */
    CONNECTED_LINE_PRESENTATION(0x13, "76"),
    /** COLR: the answering number is hidden from the caller. */
    CONNECTED_LINE_RESTRICTION(0x14, "77"),
    CALL_WAITING(0x41, "43");

    private static final int GROUP = 0xf0;
    private static final int LINE_IDENTIFICATION = 0x10;
    private static final int FORWARDING = 0x20;

    private static final List<SsCode> CONDITIONAL =
            List.of(FORWARDING_ON_BUSY, FORWARDING_ON_NO_REPLY, FORWARDING_ON_NOT_REACHABLE);

    private final int code;
    private final String typed;

    SsCode(int code, String typed) {
        this.code = code;
        this.typed = typed;
    }

    @Override
    public int code() {
        return code;
    }

    /** As typed by a user, "21". */
    public String typed() {
        return typed;
    }

    public boolean isForwarding() {
        return (code & GROUP) == FORWARDING;
    }

    /** True for services that show or hide numbers, which only the network sets. */
    public boolean isLineIdentification() {
        return (code & GROUP) == LINE_IDENTIFICATION;
    }

    /** The services of a group; a single service by itself. */
    public List<SsCode> members() {
        return switch (this) {
            case ALL_CONDITIONAL_FORWARDING -> CONDITIONAL;
            case ALL_FORWARDING ->
                List.of(
                        FORWARDING_UNCONDITIONAL,
                        FORWARDING_ON_BUSY,
                        FORWARDING_ON_NO_REPLY,
                        FORWARDING_ON_NOT_REACHABLE);
            default -> List.of(this);
        };
    }

    /** True for a group of services. */
    public boolean isGroup() {
        return this == ALL_FORWARDING || this == ALL_CONDITIONAL_FORWARDING;
    }

    public static Optional<SsCode> ofCode(int code) {
        return Coded.find(values(), code);
    }
}
