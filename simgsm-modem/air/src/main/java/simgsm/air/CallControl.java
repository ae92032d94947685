package simgsm.air;

import java.util.Optional;
import simgsm.octets.OctetString;

/** Call control messages (TS 24.008, 9.3), protocol discriminator 3. */
public sealed interface CallControl extends Layer3Message.OfTransaction {
    /** True for the 16 keys 0-9 * # A-D. */
    static boolean isKey(char key) {
        return key >= '0' && key <= '9' || key >= 'A' && key <= 'D' || key == '*' || key == '#';
    }

    private static void checkKey(char key) {
        if (!isKey(key)) {
            throw new IllegalArgumentException("key \"" + key + "\" is none of 0-9 * # A-D");
        }
    }

    /**
     * Opens a call. The mobile names the called number, the network the calling one. A mobile-originated SETUP also
     * has the speech bearer capability, written by the codec and not part of this record.
     *
     * @param signal tone that the called mobile plays
     * @param redirecting who has forwarded the call to the called mobile, the last of several
     * @param hidesNumber true to hide the caller's number in this call (CLIR invocation)
     */
    record Setup(
            TransactionIdentifier transaction,
            Optional<Signal> signal,
            Optional<Msisdn> calling,
            Optional<Msisdn> called,
            Optional<Msisdn> redirecting,
            boolean hidesNumber)
            implements CallControl {
        public Setup(TransactionIdentifier transaction, Optional<Msisdn> calling, Optional<Msisdn> called) {
            this(transaction, Optional.empty(), calling, called, Optional.empty(), false);
        }
    }

    /** Opens an emergency call, without a number. The speech bearer capability is written by the codec. */
    record EmergencySetup(TransactionIdentifier transaction) implements CallControl {}

    /** A tone played by the mobile to its user (TS 24.008, 10.5.4.23); only the codes in use. */
    enum Signal implements Coded {
        /** Another call arrives during a call. */
        CALL_WAITING(0x07);

        private final int code;

        Signal(int code) {
            this.code = code;
        }

        @Override
        public int code() {
            return code;
        }
    }

    /** @param cause 17 (user busy) if the confirmed call waits */
    record CallConfirmed(TransactionIdentifier transaction, Optional<Cause> cause) implements CallControl {
        public CallConfirmed(TransactionIdentifier transaction) {
            this(transaction, Optional.empty());
        }
    }

    record CallProceeding(TransactionIdentifier transaction) implements CallControl {}

    /** In-band information (tones) is now available. */
    record Progress(TransactionIdentifier transaction) implements CallControl {}

    /** @param inBand true if the caller hears the network's own tones from now on (progress indicator 8) */
    record Alerting(TransactionIdentifier transaction, boolean inBand) implements CallControl {
        public Alerting(TransactionIdentifier transaction) {
            this(transaction, false);
        }
    }

    /** @param connected to the caller: the answering number (TS 24.081, 3) */
    record Connect(TransactionIdentifier transaction, Optional<Msisdn> connected) implements CallControl {
        public Connect(TransactionIdentifier transaction) {
            this(transaction, Optional.empty());
        }
    }

    record ConnectAcknowledge(TransactionIdentifier transaction) implements CallControl {}

    /** A request within the call is refused. */
    interface Rejection {
        Cause cause();
    }

    /** Ends the transaction; a cause has a location. */
    interface Releasing {
        Optional<Cause> cause();

        Optional<CauseLocation> location();
    }

    /** @param key one of 0-9 * # A-D, as its ASCII character */
    record StartDtmf(TransactionIdentifier transaction, char key) implements CallControl {
        public StartDtmf {
            checkKey(key);
        }
    }

    record StartDtmfAcknowledge(TransactionIdentifier transaction, char key) implements CallControl {
        public StartDtmfAcknowledge {
            checkKey(key);
        }
    }

    record StartDtmfReject(TransactionIdentifier transaction, Cause cause) implements CallControl, Rejection {}

    record StopDtmf(TransactionIdentifier transaction) implements CallControl {}

    record StopDtmfAcknowledge(TransactionIdentifier transaction) implements CallControl {}

    /**
     * @param location the other user's, if the network passes on a cause; @param inBand true if a tone follows
     *     (progress indicator 8)
     */
    record Disconnect(TransactionIdentifier transaction, Cause cause, CauseLocation location, boolean inBand)
            implements CallControl {
        public Disconnect(TransactionIdentifier transaction, Cause cause) {
            this(transaction, cause, CauseLocation.USER, false);
        }
    }

    record Release(TransactionIdentifier transaction, Optional<Cause> cause, Optional<CauseLocation> location)
            implements CallControl, Releasing {
        public Release(TransactionIdentifier transaction, Optional<Cause> cause) {
            this(transaction, cause, cause.map(given -> CauseLocation.USER));
        }
    }

    record ReleaseComplete(TransactionIdentifier transaction, Optional<Cause> cause, Optional<CauseLocation> location)
            implements CallControl, Releasing {
        public ReleaseComplete(TransactionIdentifier transaction, Optional<Cause> cause) {
            this(transaction, cause, cause.map(given -> CauseLocation.USER));
        }
    }

    /** Requests to hold the active call (TS 24.083, 2). */
    record Hold(TransactionIdentifier transaction) implements CallControl {}

    record HoldAcknowledge(TransactionIdentifier transaction) implements CallControl {}

    record HoldReject(TransactionIdentifier transaction, Cause cause) implements CallControl, Rejection {}

    /** Requests to retrieve the held call. */
    record Retrieve(TransactionIdentifier transaction) implements CallControl {}

    record RetrieveAcknowledge(TransactionIdentifier transaction) implements CallControl {}

    record RetrieveReject(TransactionIdentifier transaction, Cause cause) implements CallControl, Rejection {}

    /** A component of a supplementary service within the call (TS 24.008, 9.3.9). @param facility the element's value */
    record Facility(TransactionIdentifier transaction, OctetString facility) implements CallControl {}

    record StatusEnquiry(TransactionIdentifier transaction) implements CallControl {}

    /** @param callState the sender's call state as coded in TS 24.008, 10.5.4.6 (0 to 28) */
    record Status(TransactionIdentifier transaction, Cause cause, int callState) implements CallControl {}
}
