package simgsm.cells.tower;

import java.util.EnumSet;
import java.util.Set;
import java.util.function.Consumer;
import simgsm.air.CipherAlgorithm;

/**
 * The settings of the air interface.
 *
 * @param algorithms that towers and mobiles can cipher with
 * @param capture takes the GSMTAP packets of all towers; null for none
 */
public record AirInterface(Set<CipherAlgorithm> algorithms, Consumer<byte[]> capture) {
    /** A5/1, no capture. */
    public static final AirInterface STANDARD = new AirInterface(EnumSet.of(CipherAlgorithm.A5_1), null);
}
