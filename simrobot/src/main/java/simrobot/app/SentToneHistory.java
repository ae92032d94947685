package simrobot.app;

import simrobot.control.ControlListener;
import vericommand.ReplyTone;

/** Remembers the reply tones of the present or last call, for the window. */
final class SentToneHistory implements ControlListener {
    private static final int KEPT = 24;

    private volatile String tones = "";

    /** Their digits, the newest last; any thread may ask. */
    String tones() {
        return tones;
    }

    @Override
    public void call(String from) {
        tones = "";
    }

    @Override
    public void toneSent(ReplyTone tone) {
        String longer = tones + tone.key();
        tones = longer.substring(Math.max(0, longer.length() - KEPT));
    }
}
