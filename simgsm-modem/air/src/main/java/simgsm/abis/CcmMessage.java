package simgsm.abis;

/** Connection control messages of the IP access multiplex: identity and keep-alive. */
public sealed interface CcmMessage {
    record Ping() implements CcmMessage {}

    record Pong() implements CcmMessage {}

    /** Asks the terminal for all identity tags. */
    record IdentityRequest() implements CcmMessage {}

    /** @param unitName the kind of terminal, as "SimGSM phone"; @param serialNumber its IMEI */
    record IdentityResponse(String unitName, String serialNumber) implements CcmMessage {}

    record IdentityAcknowledge() implements CcmMessage {}
}
