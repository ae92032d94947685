package simrobot.app.window;

import java.util.function.Consumer;
import simrobot.control.RobotEvent;

/** The keys of the reply tones of the current or last call, and the words after the newest. */
final class SentTones implements Consumer<RobotEvent> {
    private static final int MAX_TONES = 24;

    private volatile String keys = "";
    private volatile String words = "";

    /** At most 24, newest last; callable on any thread. */
    String keys() {
        return keys;
    }

    /** The modem's current or latest words; callable on any thread. */
    String words() {
        return words;
    }

    @Override
    public void accept(RobotEvent event) {
        if (event instanceof RobotEvent.CallReceived) {
            keys = "";
            words = "";
        } else if (event instanceof RobotEvent.ToneSent tone) {
            String longer = keys + tone.key();
            keys = longer.substring(Math.max(0, longer.length() - MAX_TONES));
            words = "";
        } else if (event instanceof RobotEvent.Said said) {
            words = said.text();
        }
    }
}
