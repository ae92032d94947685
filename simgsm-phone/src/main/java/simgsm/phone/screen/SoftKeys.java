package simgsm.phone.screen;

/**
 * The functions of the two keys under the display.
 *
 * @param left text key; empty if the key has no function
 * @param right likewise
 */
public record SoftKeys(String left, String right) {
    static final SoftKeys NONE = new SoftKeys("", "");
    static final SoftKeys SELECT = new SoftKeys("soft.select", "soft.back");
    static final SoftKeys BACK = new SoftKeys("", "soft.back");
    static final SoftKeys OK = new SoftKeys("soft.ok", "soft.back");
}
