package simgsm.tools.load;

import java.util.List;

/**
 * Short messages from each station to the next, a limited number at a time. Each text contains its number and a
 * prefix of this run, because messages of an earlier run may still be pending.
 */
final class MessageLoad {
    private final List<LoadStation> phones;
    private final TaskWindow window;
    private final String prefix =
            "load " + Long.toString(System.nanoTime() & Long.MAX_VALUE, Character.MAX_RADIX) + " ";
    private final long[] sentNanos;
    private final DelayHistogram delays = new DelayHistogram();

    MessageLoad(List<LoadStation> phones, int count, int width) {
        this.phones = phones;
        sentNanos = new long[count];
        window = new TaskWindow(count, width, this::send);
    }

    TaskWindow window() {
        return window;
    }

    /** From sending to the text's arrival. */
    DelayHistogram delays() {
        return delays;
    }

    private void send(int message) {
        LoadStation from = phones.get(message % phones.size());
        LoadStation to = phones.get((message + 1) % phones.size());
        sentNanos[message] = System.nanoTime();
        from.station.sendMessage(to.number(), prefix + message);
    }

    void arrived(String text) {
        if (text.startsWith(prefix)) {
            int message = Integer.parseInt(text.substring(prefix.length()));
            delays.add(System.nanoTime() - sentNanos[message]);
            window.ended(message, true);
        }
    }
}
