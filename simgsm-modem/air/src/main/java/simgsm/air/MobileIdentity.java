package simgsm.air;

/** An identity of a mobile in a message (TS 24.008, 10.5.1.4). */
public sealed interface MobileIdentity permits Imsi, Imei, Imeisv, Tmsi {
    /** The kinds of identity in IDENTITY REQUEST, with their codes (TS 24.008, 10.5.3.4). */
    enum Type implements Coded {
        IMSI(1),
        IMEI(2),
        IMEISV(3),
        TMSI(4);

        private final int code;

        Type(int code) {
            this.code = code;
        }

        @Override
        public int code() {
            return code;
        }
    }

    Type type();
}
