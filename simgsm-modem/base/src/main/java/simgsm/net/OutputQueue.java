package simgsm.net;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.function.Consumer;

/**
 * Messages not yet taken by a peer. Each is written by its own write, so that an observer of the wire sees one
 * message per segment while the peer keeps up; only successive droppable messages share a write, since a write costs
 * more than their content. A message written in parts stays whole. Droppable messages beyond their limit replace the
 * oldest of their kind.
 */
public final class OutputQueue {
    private record Message(ByteBuffer octets, boolean isDroppable) {}

    private final int most;
    private final int mostDroppable;
    private final Consumer<byte[]> written;
    private final ArrayDeque<Message> queue = new ArrayDeque<>();
    private int droppable;
    private long dropped;
    private long taken;

    /**
     * @param most waiting messages, droppable ones not counted
     * @param mostDroppable waiting droppable messages
     * @param written called with each message after its last octet has been written
     */
    public OutputQueue(int most, int mostDroppable, Consumer<byte[]> written) {
        this.most = most;
        this.mostDroppable = mostDroppable;
        this.written = written;
    }

    /** @return false if too many messages wait: the peer does not read */
    public boolean add(byte[] message, boolean isDroppable) {
        if (isDroppable && dropsNext()) {
            dropOldest();
        }
        droppable += isDroppable ? 1 : 0;
        queue.addLast(new Message(ByteBuffer.wrap(message), isDroppable));
        return queue.size() - droppable <= most;
    }

    /** Writes until the channel takes no more or the queue is empty. */
    public void flush(WritableByteChannel channel) throws IOException {
        while (!queue.isEmpty()) {
            ByteBuffer octets = ofNextWrite();
            channel.write(octets);
            remove(octets.position());
            if (octets.hasRemaining()) {
                return;
            }
        }
    }

    /** The first message, or the droppable messages up to the next other one. */
    private ByteBuffer ofNextWrite() {
        Message first = queue.peekFirst();
        if (!first.isDroppable || droppable == 1) {
            return first.octets.slice();
        }
        ByteArrayOutputStream joined = new ByteArrayOutputStream();
        queue.stream()
                .takeWhile(Message::isDroppable)
                .map(Message::octets)
                .forEach(each -> joined.write(each.array(), each.position(), each.remaining()));
        return ByteBuffer.wrap(joined.toByteArray());
    }

    /** The channel has taken this many octets. */
    private void remove(int octets) {
        for (int rest = octets; rest > 0; ) {
            Message first = queue.peekFirst();
            int part = Math.min(rest, first.octets.remaining());
            rest -= part;
            first.octets.position(first.octets.position() + part);
            if (!first.octets.hasRemaining()) {
                queue.removeFirst();
                droppable -= first.isDroppable ? 1 : 0;
                taken++;
                written.accept(first.octets.array());
            }
        }
    }

    /** True if a further droppable message replaces a waiting one. */
    public boolean dropsNext() {
        return droppable == mostDroppable;
    }

    public boolean isEmpty() {
        return queue.isEmpty();
    }

    public int size() {
        return queue.size();
    }

    /** Messages whose last octet has been written so far. */
    public long taken() {
        return taken;
    }

    /** Droppable messages dropped so far. */
    public long dropped() {
        return dropped;
    }

    /** A partly written message is kept, since the peer would lose the framing. */
    private void dropOldest() {
        for (Iterator<Message> each = queue.iterator(); each.hasNext(); ) {
            Message candidate = each.next();
            if (candidate.isDroppable && candidate.octets.position() == 0) {
                each.remove();
                droppable--;
                dropped++;
                return;
            }
        }
    }
}
