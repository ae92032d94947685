package simgsm.abis;

/** Connection control messages of the IP access multiplex: identity and keep-alive. */
public sealed interface CcmMessage {
    record Ping() implements CcmMessage {}

    record Pong() implements CcmMessage {}

    /** Asks the terminal for all identity tags. */
    record IdentityRequest() implements CcmMessage {}

    /**
     * Identity of the peer.
     *
     * @param unitName kind of terminal, as "SimGSM phone"
     * @param serialNumber IMEI of a terminal
     * @param unitId of a tower site, BTS and transceiver, as "6969/0/0"; empty for a terminal
     */
    record IdentityResponse(String unitName, String serialNumber, String unitId) implements CcmMessage {
        /** Identity of a terminal. */
        public IdentityResponse(String unitName, String serialNumber) {
            this(unitName, serialNumber, "");
        }

        /** True if the peer is a tower. */
        public boolean isTower() {
            return !unitId.isEmpty();
        }
    }

    record IdentityAcknowledge() implements CcmMessage {}
}
