package simgsm.cells.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.cells.network.CellNetwork;
import simgsm.cells.tower.BaseStation;
import simgsm.net.Acceptor;
import simgsm.net.ConnectionLimits;
import simgsm.net.SelectorLoop;

/** The thread that owns the towers and mobiles, the terminals' port and the towers' connections to the controller. */
public final class CellsLoop implements AutoCloseable {
    private static final int MOST_TERMINALS = 20_000;
    private static final int MOST_PER_ADDRESS = 500;

    private final SelectorLoop loop = new SelectorLoop("cells");
    private final long startNanos = System.nanoTime();
    private final CellNetwork network;
    private final Acceptor terminals;
    private final List<TowerLink> towers = new ArrayList<>();

    private final class Driver implements SelectorLoop.Core {
        @Override
        public long nextDeadlineNanos() {
            return network.nextDeadlineNanos().isPresent()
                    ? startNanos + network.nextDeadlineNanos().getAsLong()
                    : SelectorLoop.NEVER;
        }

        @Override
        public void advance(long loopNanos) {
            network.advance(loopNanos - startNanos);
        }
    }

    /**
     * Opens the port; {@link #start} begins accepting terminals.
     *
     * @param port 0 for any free one
     * @throws IOException naming address and port
     */
    public CellsLoop(CellNetwork network, InetAddress address, int port) throws IOException {
        this.network = network;
        try {
            terminals = loop.listen(
                    new InetSocketAddress(address, port),
                    new ConnectionLimits(MOST_TERMINALS, MOST_PER_ADDRESS),
                    endpoint -> new MobileConnection(endpoint, this));
        } catch (IOException e) {
            loop.close();
            throw e;
        }
    }

    public int port() {
        return terminals.port();
    }

    /**
     * Starts the thread; each tower connects to the controller.
     *
     * @param controller may be unresolved
     * @param onFailure called when an error has ended the thread
     */
    public void start(InetSocketAddress controller, Consumer<Throwable> onFailure) {
        loop.start(new Driver(), onFailure);
        loop.post(() -> {
            for (BaseStation tower : network.towers()) {
                towers.add(new TowerLink(this, loop, tower, controller));
            }
        });
    }

    /** Shows the core on the owner thread, at once and after each period. Callable on any thread. */
    public void observe(long periodNanos, Consumer<CellNetwork> observer) {
        loop.post(() -> {
            observer.accept(now());
            loop.after(periodNanos, () -> observe(periodNanos, observer));
        });
    }

    /** The core, advanced to the current time. */
    CellNetwork now() {
        network.advance(System.nanoTime() - startNanos);
        return network;
    }

    /** Switches a tower; it is connected only while on. */
    public void switchTower(BaseStation tower, boolean on) {
        now().switchTower(tower, on);
        towers.stream().filter(link -> link.isOf(tower)).forEach(link -> link.switchTo(on));
    }

    /** Queues a task of the owner thread. Callable on any thread. */
    public void post(Consumer<CellNetwork> task) {
        loop.post(() -> task.accept(now()));
    }

    /**
     * Runs a question on the owner thread. Callable on any thread.
     *
     * @throws IllegalStateException as {@link SelectorLoop#ask}
     */
    public <T> T ask(Function<CellNetwork, T> question) {
        return loop.ask(() -> question.apply(now()));
    }

    @Override
    public void close() {
        loop.close();
    }
}
