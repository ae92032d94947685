package simgsm.air;

/** Temporary mobile subscriber identity: four octets assigned by a visitor location register (TS 23.003, 2.4). */
public record Tmsi(int value) implements MobileIdentity {
    @Override
    public Type type() {
        return Type.TMSI;
    }

    @Override
    public String toString() {
        return String.format("%08x", value);
    }
}
