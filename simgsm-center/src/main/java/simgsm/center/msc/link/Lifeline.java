package simgsm.center.msc.link;

/** A party of the ladder diagram: a mobile or a tower. */
public interface Lifeline {
    /** Its current name. */
    String lifeline();

    /** True if this name is final: a mobile's number, not what stands for it before its registration. */
    boolean hasNumber();

    /** True while its radio connection is ciphered on the air. */
    default boolean isCiphered() {
        return false;
    }
}
