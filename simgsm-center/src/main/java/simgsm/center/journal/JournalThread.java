package simgsm.center.journal;

import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import simgsm.center.smsc.MessageStore;
import simgsm.center.smsc.StoreEntry;

/**
 * The thread that owns the journal. Whatever has come while the disk was busy goes to it in one group with one
 * synchronisation, so that the disk's pace sets the size of the groups and not the number of messages.
 */
public final class JournalThread implements MessageStore, AutoCloseable {
    private static final System.Logger LOG = System.getLogger(JournalThread.class.getName());
    /** A group's octets stay below about a megabyte. */
    private static final int MAX_GROUP = 4_000;

    private static final long RETRY_MILLIS = 500;

    private record Order(long ticket, StoreEntry entry) {}

    /** Ends the thread once everything before it is done. */
    private static final Order END = new Order(0, null);

    /** Hears what has become of each group, on the journal's thread. */
    public interface Answers {
        /** @param tickets in the order of the commits */
        void committed(List<Long> tickets, boolean isDurable);
    }

    private final Journal journal;
    private final Answers answers;
    private final BlockingQueue<Order> orders = new LinkedBlockingQueue<>();
    private final Thread thread = new Thread(this::run, "journal");

    public JournalThread(Journal journal, Answers answers) {
        this.journal = journal;
        this.answers = answers;
    }

    public void start() {
        thread.start();
    }

    @Override
    public void commit(long ticket, StoreEntry entry) {
        orders.add(new Order(ticket, entry));
    }

    private void run() {
        List<Order> group = new ArrayList<>();
        boolean isEnding = false;
        while (!isEnding) {
            group.clear();
            collect(group);
            isEnding = group.remove(END);
            if (!group.isEmpty() || journal.isFailing()) {
                answers.committed(group.stream().map(Order::ticket).toList(), isCommitted(group));
            }
            journal.compact();
        }
        journal.close();
    }

    /** A fault of ours refuses a group; it does not end the thread. */
    private boolean isCommitted(List<Order> group) {
        try {
            return journal.commit(group.stream().map(Order::entry).toList());
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "an error of our own in the journal", e);
            return false;
        }
    }

    /** Waits for something to do: orders, or a reason not to wait for any. */
    private void collect(List<Order> group) {
        try {
            Order first = journal.isCompacting()
                    ? orders.poll()
                    : journal.isFailing() ? orders.poll(RETRY_MILLIS, TimeUnit.MILLISECONDS) : orders.take();
            if (first != null) {
                group.add(first);
                orders.drainTo(group, MAX_GROUP - 1);
            }
        } catch (InterruptedException e) {
            group.add(END);
        }
    }

    /** Writes what has been handed in, and ends the thread. */
    @Override
    public void close() {
        if (!thread.isAlive()) {
            return;
        }
        orders.add(END);
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
