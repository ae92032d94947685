package simgsm.web;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import simgsm.net.Connection;
import simgsm.net.Connector;
import simgsm.net.OutputQueue;
import simgsm.net.SelectorLoop;

/** The connection to the pages' server for one client's. A side that does not read stops the other's reading. */
final class PassedConnection implements Connector.Listener {
    private final DoorConnection client;
    private final WebDoor door;
    private final Connector connector;
    private final OutputQueue toPages = new OutputQueue(Integer.MAX_VALUE, 0, written -> {});
    /** Null until connected. */
    private Pages pages;

    private boolean isEnded;
    private boolean isAnswerComplete;

    PassedConnection(SelectorLoop loop, DoorConnection client, WebDoor door) {
        this.client = client;
        this.door = door;
        connector = new Connector(loop, door.pages(), this);
        connector.start();
    }

    void fromClient(ByteBuffer octets) {
        toPages.add(octets(octets), false);
        client.setReading(false);
        if (pages != null) {
            pages.flush();
        }
    }

    void clientHasTakenAll() {
        if (isAnswerComplete) {
            client.fail("the answer is complete");
        } else if (pages != null) {
            pages.resume();
        }
    }

    void clientEnded() {
        isEnded = true;
        connector.close();
    }

    @Override
    public Connection connected(Connection.Endpoint endpoint) {
        pages = new Pages(endpoint);
        return pages;
    }

    @Override
    public void failed(String reason) {
        connector.close();
        client.fail("the pages' server: " + reason);
    }

    private static byte[] octets(ByteBuffer from) {
        byte[] octets = new byte[from.remaining()];
        from.get(octets);
        return octets;
    }

    private final class Pages extends Connection {
        private final int port;

        Pages(Endpoint endpoint) {
            super(endpoint);
            port = endpoint.channel().socket().getLocalPort();
            door.passed(port, client.address());
        }

        @Override
        protected void opened() {
            flush();
        }

        @Override
        protected void received(ByteBuffer octets) {
            pauseReading();
            client.send(octets(octets), false);
        }

        void resume() {
            if (isOpen()) {
                resumeReading();
            }
        }

        @Override
        protected boolean hasOutput() {
            return !toPages.isEmpty();
        }

        @Override
        protected void writeTo(WritableByteChannel channel) throws IOException {
            toPages.flush(channel);
            if (toPages.isEmpty() && client.isOpen()) {
                client.setReading(true);
            }
        }

        @Override
        protected void closing(boolean isByPeer) {
            door.ended(port);
            if (!isEnded) {
                isAnswerComplete = true;
                connector.close();
                client.flush();
            }
        }
    }
}
