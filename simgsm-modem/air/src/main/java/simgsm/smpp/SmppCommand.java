package simgsm.smpp;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** Commands that the centre implements (5.1.2.1). */
public enum SmppCommand {
    /** Exists only as a response. */
    GENERIC_NACK(0x000),
    BIND_RECEIVER(0x001),
    BIND_TRANSMITTER(0x002),
    QUERY_SM(0x003),
    SUBMIT_SM(0x004),
    DELIVER_SM(0x005),
    UNBIND(0x006),
    REPLACE_SM(0x007),
    CANCEL_SM(0x008),
    BIND_TRANSCEIVER(0x009),
    ENQUIRE_LINK(0x015),
    SUBMIT_MULTI(0x021),
    DATA_SM(0x103);

    /** Bit of the command_id of responses. */
    public static final int RESPONSE = 0x8000_0000;

    private static final Map<Integer, SmppCommand> BY_CODE = new HashMap<>();

    static {
        for (SmppCommand command : values()) {
            BY_CODE.put(command.code, command);
        }
    }

    private final int code;

    SmppCommand(int code) {
        this.code = code;
    }

    /** The command_id of the request. */
    public int code() {
        return code;
    }

    public boolean isBind() {
        return this == BIND_RECEIVER || this == BIND_TRANSMITTER || this == BIND_TRANSCEIVER;
    }

    static Optional<SmppCommand> ofCode(int code) {
        return Optional.ofNullable(BY_CODE.get(code & ~RESPONSE));
    }
}
