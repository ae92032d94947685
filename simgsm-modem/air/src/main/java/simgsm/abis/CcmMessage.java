package simgsm.abis;

/** Connection control messages of the IP access multiplex: who the peer is, and whether it still lives. */
public sealed interface CcmMessage {
    record Ping() implements CcmMessage {}

    record Pong() implements CcmMessage {}

    /** The network asks for all identity tags. */
    record IdentityRequest() implements CcmMessage {}

    /** @param unitName what the terminal is, as "SimGSM phone"; @param serialNumber its IMEI */
    record IdentityResponse(String unitName, String serialNumber) implements CcmMessage {}

    record IdentityAcknowledge() implements CcmMessage {}
}
