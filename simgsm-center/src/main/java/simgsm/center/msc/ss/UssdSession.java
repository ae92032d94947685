package simgsm.center.msc.ss;

import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.ss.SsError;

/** A dialogue that a mobile has begun, as a service sees it. After the end, from either side, calls do nothing. */
public interface UssdSession {
    /** The subscriber who asks. */
    Msisdn subscriber();

    /** Shows a text and waits for the user's reply; not while another one is awaited. */
    void ask(String text, Consumer<String> reply);

    /** Ends the dialogue with its last text. */
    void end(String text);

    /** Ends the dialogue with an error. */
    void fail(SsError error);
}
