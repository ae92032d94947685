package simgsm.tools.load;

import java.util.List;

/**
 * Short messages from each station to the next, so many under way at a time. Each text carries its number, and a mark of
 * this run, since an earlier run's message may still wait for one of our numbers.
 */
final class MessageRound {
    private final List<LoadPhone> phones;
    private final Window window;
    private final String mark = "load " + Long.toString(System.nanoTime() & Long.MAX_VALUE, Character.MAX_RADIX) + " ";
    private final long[] sentNanos;
    private final Delays delays = new Delays();

    MessageRound(List<LoadPhone> phones, int count, int width) {
        this.phones = phones;
        sentNanos = new long[count];
        window = new Window(count, width, this::send);
    }

    Window window() {
        return window;
    }

    /** From the act of sending to the text's arrival. */
    Delays delays() {
        return delays;
    }

    private void send(int message) {
        LoadPhone from = phones.get(message % phones.size());
        LoadPhone to = phones.get((message + 1) % phones.size());
        sentNanos[message] = System.nanoTime();
        from.station.sendMessage(to.number(), mark + message);
    }

    void arrived(String text) {
        if (text.startsWith(mark)) {
            int message = Integer.parseInt(text.substring(mark.length()));
            delays.add(System.nanoTime() - sentNanos[message]);
            window.ended(message, true);
        }
    }
}
