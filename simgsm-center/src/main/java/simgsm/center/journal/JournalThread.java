package simgsm.center.journal;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.center.smsc.HeapShare;
import simgsm.center.smsc.MessageStore;
import simgsm.center.smsc.StoreEntry;
import simgsm.thread.DaemonThread;

/**
 * The thread that owns the journal. It writes commits that arrive while the disk is busy, and on a slow disk a little
 * later, as one group with one synchronisation.
 */
public final class JournalThread implements MessageStore, AutoCloseable {
    /** Maximum of commits in a group; about 1 MB, or less in a small heap. */
    private static final int MAX_GROUP = HeapShare.count(4_000, 1_500);

    private static final long RETRY_MILLIS = 500;

    private record Order(long ticket, List<StoreEntry> entries) {
        boolean isRefusable() {
            return entries.stream().anyMatch(StoreEntry.Accepted.class::isInstance);
        }
    }

    /** Ends the thread after all preceding orders. */
    private static final Order END = new Order(NO_TICKET, List.of());

    /** Receives the outcome of each group, on the journal's thread. */
    public interface Answers {
        /** @param tickets in the order of the commits */
        void committed(List<Long> tickets, boolean isDurable);
    }

    private final Journal journal;
    private final Answers answers;
    private final BlockingQueue<Order> orders = new LinkedBlockingQueue<>();
    private final CommitGroups<Order> groups = new CommitGroups<>(System::nanoTime);
    private final Thread thread = new Thread(this::run, "journal");
    private Consumer<Throwable> onFailure;

    public JournalThread(Journal journal, Answers answers) {
        this.journal = journal;
        this.answers = answers;
    }

    /** @param failed called when an exception has ended the thread; nothing is stored afterwards */
    public void start(Consumer<Throwable> failed) {
        onFailure = failed;
        thread.start();
    }

    @Override
    public void commit(long ticket, List<StoreEntry> entries) {
        orders.add(new Order(ticket, entries));
    }

    private void run() {
        try {
            writeUntilEnd();
        } catch (Throwable fault) {
            onFailure.accept(fault);
        }
    }

    private void writeUntilEnd() {
        List<Order> group = new ArrayList<>();
        boolean isEnding = false;
        while (!isEnding) {
            group.clear();
            collect(group);
            isEnding = group.removeIf(order -> order == END);
            if (!group.isEmpty() || journal.isFailing()) {
                long began = System.nanoTime();
                boolean isDurable = journal.commit(
                        group.stream().flatMap(order -> order.entries.stream()).toList());
                groups.written(group.size(), System.nanoTime() - began);
                answers.committed(group.stream().map(Order::ticket).toList(), isDurable);
            }
            journal.compact();
        }
        journal.close();
    }

    /** Takes the next group; waits for one, but not while compacting, and at most 0.5 s while the disk fails. */
    private void collect(List<Order> group) {
        try {
            Order first = journal.isCompacting()
                    ? orders.poll()
                    : journal.isFailing() ? orders.poll(RETRY_MILLIS, TimeUnit.MILLISECONDS) : orders.take();
            if (first != null) {
                group.add(first);
                groups.gather(group, MAX_GROUP, nanos -> next(first, nanos));
            }
        } catch (InterruptedException e) {
            group.add(END);
        }
    }

    /** Separates new messages from ends while the disk fails, because new messages are refused and ends are stored. */
    private Order next(Order first, long nanos) throws InterruptedException {
        Order head = orders.peek();
        if (journal.isFailing()) {
            return head != null && head.isRefusable() == first.isRefusable() ? orders.poll() : null;
        }
        return head == null && nanos > 0 ? orders.poll(nanos, TimeUnit.NANOSECONDS) : orders.poll();
    }

    /** Writes all commits so far and ends the thread. */
    @Override
    public void close() {
        if (thread.getState() == Thread.State.NEW) {
            journal.close();
        }
        if (!thread.isAlive()) {
            return;
        }
        orders.add(END);
        DaemonThread.join(thread, 0);
    }
}
