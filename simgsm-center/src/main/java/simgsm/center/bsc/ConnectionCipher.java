package simgsm.center.bsc;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.CipherAlgorithm;
import simgsm.air.Direction;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Type;
import simgsm.air.RadioResource.CipheringModeCommand;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** The ciphering of one radio connection (TS 44.018, 3.4.7): begun once, and kept on its further channels. */
final class ConnectionCipher {
    /** In the first octet of a classmark: A5/1 is not available. */
    private static final int NO_A5_1 = 0x08;
    /** In the third octet of classmark 2: A5/3 is available. */
    private static final int A5_3 = 0x02;

    private final RadioConnection connection;
    private CipherAlgorithm available = CipherAlgorithm.A5_0;
    private CipherAlgorithm algorithm = CipherAlgorithm.A5_0;
    private OctetString key;
    private boolean isOn;
    /** Null unless the mobile's answer is awaited. */
    private Consumer<Boolean> awaiting;

    ConnectionCipher(RadioConnection connection) {
        this.connection = connection;
    }

    /** Reads what the mobile can cipher with, in its first message. */
    void readClassmark(OctetString firstMessage) {
        available = best(firstMessage);
    }

    /** Ciphers the connection, unless it is, or the mobile cannot. @param done receives true if it has begun */
    void begin(OctetString kc, Consumer<Boolean> done) {
        if (algorithm != CipherAlgorithm.A5_0 || available == CipherAlgorithm.A5_0 || connection.isSuspended()) {
            done.accept(false);
            return;
        }
        algorithm = available;
        key = kc;
        awaiting = done;
        connection
                .channel()
                .cipher(information().orElseThrow(), connection.traced(new CipheringModeCommand(algorithm, 0)));
    }

    private static CipherAlgorithm best(OctetString message) {
        int discriminator = message.octet(0);
        int type = message.octet(1) & 0x3f;
        boolean isClassmark2 =
                discriminator == Layer3Header.RADIO_RESOURCE || type == Layer3Type.CM_SERVICE_REQUEST.code();
        int at = isClassmark2 ? 4 : type == Layer3Type.LOCATION_UPDATING_REQUEST.code() ? 8 : 2;
        if (isClassmark2 && message.length() > at + 2 && (message.octet(at + 2) & A5_3) != 0) {
            return CipherAlgorithm.A5_3;
        }
        boolean hasA51 = message.length() > at && (message.octet(at) & NO_A5_1) == 0;
        return hasA51 ? CipherAlgorithm.A5_1 : CipherAlgorithm.A5_0;
    }

    /** True once the mobile ciphers. */
    boolean isOn() {
        return isOn;
    }

    /** TS 48.058, 9.3.7; empty without ciphering. */
    Optional<OctetString> information() {
        return algorithm == CipherAlgorithm.A5_0
                ? Optional.empty()
                : Optional.of(
                        new OctetWriter().octet(algorithm.rsl()).string(key).toOctetString());
    }

    /** Handles CIPHERING MODE COMPLETE. @return false for any other message */
    boolean receive(OctetString layer3) {
        boolean isComplete = awaiting != null
                && layer3.length() > 1
                && layer3.octet(0) == Layer3Header.RADIO_RESOURCE
                && layer3.octet(1) == Layer3Type.CIPHERING_MODE_COMPLETE.code();
        if (isComplete) {
            isOn = true;
            connection.mobile().link().trace(Direction.UPLINK, Layer3Type.CIPHERING_MODE_COMPLETE.title(), layer3);
            Consumer<Boolean> done = awaiting;
            awaiting = null;
            done.accept(true);
        }
        return isComplete;
    }
}
