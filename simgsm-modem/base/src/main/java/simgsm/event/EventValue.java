package simgsm.event;

/** A component that is printed as another value, such as a cause as its code. */
public interface EventValue {
    Object eventValue();
}
