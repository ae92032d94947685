package simgsm.air;

/** Causes of refusals of short messages by the relay layer (TS 24.011, 8.2.5.4). */
public enum RpCause implements Coded.Titled {
    UNASSIGNED_NUMBER(1, "unassigned number"),
    OPERATOR_DETERMINED_BARRING(8, "operator determined barring"),
    CALL_BARRED(10, "call barred"),
    SHORT_MESSAGE_TRANSFER_REJECTED(21, "short message transfer rejected"),
    MEMORY_CAPACITY_EXCEEDED(22, "memory capacity exceeded"),
    DESTINATION_OUT_OF_ORDER(27, "destination out of order"),
    UNIDENTIFIED_SUBSCRIBER(28, "unidentified subscriber"),
    FACILITY_REJECTED(29, "facility rejected"),
    UNKNOWN_SUBSCRIBER(30, "unknown subscriber"),
    NETWORK_OUT_OF_ORDER(38, "network out of order"),
    TEMPORARY_FAILURE(41, "temporary failure"),
    CONGESTION(42, "congestion"),
    RESOURCES_UNAVAILABLE(47, "resources unavailable, unspecified"),
    INVALID_REFERENCE(81, "invalid short message transfer reference value"),
    SEMANTICALLY_INCORRECT_MESSAGE(95, "semantically incorrect message"),
    INVALID_MANDATORY_INFORMATION(96, "invalid mandatory information"),
    MESSAGE_TYPE_NON_EXISTENT(97, "message type non-existent or not implemented"),
    MESSAGE_NOT_COMPATIBLE(98, "message not compatible with protocol state"),
    PROTOCOL_ERROR(111, "protocol error, unspecified"),
    INTERWORKING(127, "interworking, unspecified");

    private final Row row;

    RpCause(int code, String title) {
        row = new Row(code, title);
    }

    @Override
    public Row row() {
        return row;
    }

    /** The cause with this code; PROTOCOL_ERROR for an unlisted code. */
    public static RpCause ofCode(int code) {
        return Coded.find(values(), code).orElse(PROTOCOL_ERROR);
    }
}
