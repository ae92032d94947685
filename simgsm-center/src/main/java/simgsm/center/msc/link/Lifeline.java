package simgsm.center.msc.link;

/** A party of the ladder diagram: a mobile or a tower. */
public interface Lifeline {
    /** The name under which it is shown now. */
    String lifeline();

    /** Whether this name is final: a mobile's number, and not the address before it has registered. */
    boolean hasNumber();
}
