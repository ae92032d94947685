package simgsm.center.demo;

/** A step of the demo that did not go as it should; the text says which and what was expected. */
final class DemoFailure extends Exception {
    DemoFailure(String text) {
        super(text);
    }
}
