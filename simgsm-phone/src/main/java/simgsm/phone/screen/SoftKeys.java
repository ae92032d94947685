package simgsm.phone.screen;

/**
 * What the two keys under the display do on this screen.
 *
 * @param left key of the bundle; empty if the key does nothing
 * @param right as left
 */
public record SoftKeys(String left, String right) {
    static final SoftKeys NONE = new SoftKeys("", "");
    static final SoftKeys SELECT = new SoftKeys("soft.select", "soft.back");
    static final SoftKeys BACK = new SoftKeys("", "soft.back");
    static final SoftKeys OK = new SoftKeys("soft.ok", "soft.back");
}
