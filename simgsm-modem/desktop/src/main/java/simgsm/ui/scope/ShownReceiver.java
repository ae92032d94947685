package simgsm.ui.scope;

import java.util.function.Function;
import simgsm.scope.ReceiverTrace;
import simgsm.scope.ToneTrace;

/** The two receivers of a tone scope. */
enum ShownReceiver {
    MODEM("scope.receiver.modem", ToneTrace::modem),
    CLASSIC("scope.receiver.classic", ToneTrace::classic);

    /** Key of the name's text; the tool tip's ends with ".tip". */
    final String key;

    private final Function<ToneTrace, ReceiverTrace> part;

    ShownReceiver(String key, Function<ToneTrace, ReceiverTrace> part) {
        this.key = key;
        this.part = part;
    }

    /** The receiver's part of the trace. */
    ReceiverTrace of(ToneTrace trace) {
        return part.apply(trace);
    }
}
