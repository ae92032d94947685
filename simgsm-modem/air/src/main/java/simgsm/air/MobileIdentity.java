package simgsm.air;

/** How a mobile names itself on the air (TS 24.008, 10.5.1.4). */
public sealed interface MobileIdentity permits Imsi, Imei, Tmsi {
    /** The kinds of identity that IDENTITY REQUEST may ask for, with their codes (TS 24.008, 10.5.3.4). */
    enum Type {
        IMSI(1),
        IMEI(2),
        IMEISV(3),
        TMSI(4);

        private final int code;

        Type(int code) {
            this.code = code;
        }

        public int code() {
            return code;
        }

        /** The type with this code; IllegalArgumentException for an unassigned one. */
        public static Type ofCode(int code) {
            for (Type type : values()) {
                if (type.code == code) {
                    return type;
                }
            }
            throw new IllegalArgumentException("identity type " + code + " is not 1 to 4");
        }
    }

    Type type();
}
