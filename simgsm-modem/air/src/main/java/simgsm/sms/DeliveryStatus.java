package simgsm.sms;

import java.util.Map;

/** TP-ST of a status report (TS 23.040, 9.2.3.15). */
public final class DeliveryStatus {
    public static final int DELIVERED = 0x00;
    public static final int INCOMPATIBLE_DESTINATION = 0x41;
    public static final int CONNECTION_REJECTED_BY_RECEIVER = 0x42;
    public static final int NOT_OBTAINABLE = 0x43;
    public static final int VALIDITY_EXPIRED = 0x46;
    public static final int DELETED_BY_ORIGINATOR = 0x47;
    public static final int DELETED_BY_CENTER = 0x48;
    public static final int DOES_NOT_EXIST = 0x49;

    private static final Map<Integer, String> TITLES = Map.ofEntries(
            Map.entry(DELIVERED, "delivered"),
            Map.entry(0x01, "forwarded, delivery not confirmed"),
            Map.entry(0x02, "replaced by the centre"),
            Map.entry(0x40, "remote procedure error"),
            Map.entry(INCOMPATIBLE_DESTINATION, "incompatible destination"),
            Map.entry(CONNECTION_REJECTED_BY_RECEIVER, "connection rejected by the receiver"),
            Map.entry(NOT_OBTAINABLE, "not obtainable"),
            Map.entry(0x45, "no interworking available"),
            Map.entry(VALIDITY_EXPIRED, "validity period expired"),
            Map.entry(DELETED_BY_ORIGINATOR, "deleted by the originator"),
            Map.entry(DELETED_BY_CENTER, "deleted by the centre"),
            Map.entry(DOES_NOT_EXIST, "message does not exist"));

    private DeliveryStatus() {}

    /** True if the receiver has the message. */
    public static boolean isDelivered(int status) {
        return status < 0x20;
    }

    /** True if the centre makes further attempts. */
    public static boolean isPending(int status) {
        return status >= 0x20 && status < 0x40;
    }

    /** The status in words, in English. */
    public static String title(int status) {
        String fallback = isPending(status)
                ? "still trying"
                : status < 0x60 ? "given up, permanent error" : "given up, temporary error";
        return TITLES.getOrDefault(status, isDelivered(status) ? "completed" : fallback);
    }
}
