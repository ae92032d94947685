package simgsm.gateway;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZonedDateTime;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import simgsm.console.TextBundle;
import simgsm.file.FileErrors;
import simgsm.file.FileReplacement;
import simgsm.gateway.esme.Application;
import simgsm.gateway.esme.TextDelivery;
import simgsm.gateway.fax.Fax;
import simgsm.smpp.SmppStatus;
import simgsm.station.StationThread;
import simgsm.thread.DaemonThread;

/**
 * Writes messages to one number as fax files, and answers each after its file is on the disk. Belongs to the stations'
 * thread; a thread of its own writes.
 */
final class FaxPort {
    private final StationThread thread;
    private final FaxOptions options;
    private final TextBundle words;
    private final Consumer<GatewayEvent> listener;
    private final CoreTime time;
    private final EsmePort port;
    private final Application application;
    private final ExecutorService writer = DaemonThread.executor("fax");

    /** @throws IOException if the folder cannot be made or written */
    FaxPort(StationThread thread, FaxOptions options, Locale language, Consumer<GatewayEvent> listener)
            throws IOException {
        Files.createDirectories(options.folder());
        if (!Files.isWritable(options.folder())) {
            throw new FileSystemException(options.folder().toString(), null, "the folder is write-protected");
        }
        this.thread = thread;
        this.options = options;
        this.listener = listener;
        words = PageWords.own(language);
        time = new CoreTime(thread);
        port = new EsmePort(thread, options.smpp(), GatewayEvent.FAX, listener);
        application = new Application(
                time.timers(),
                options.smpp().bind(options.number(), options.number().digits()),
                port,
                this::whole);
    }

    void start() throws InterruptedException {
        port.start(application, time);
    }

    EsmePort application() {
        return port;
    }

    private void whole(TextDelivery delivery) {
        Fax fax = Fax.of(
                delivery.id(), delivery.number(), options.number().digits(), delivery.text(), ZonedDateTime.now());
        if (fax.pages().size() > Fax.MOST_PAGES) {
            failed(fax, delivery, "over " + Fax.MOST_PAGES + " pages", SmppStatus.PERMANENT_APPLICATION_ERROR);
        } else {
            writer.execute(() -> write(fax, delivery));
        }
    }

    private void write(Fax fax, TextDelivery delivery) {
        Path file = options.folder().resolve("fax-" + fax.id() + ".tif");
        try {
            FileReplacement.writeDurably(file, fax.tiff(header -> words.of("fax.header", header)));
            thread.execute(() -> {
                listener.accept(new GatewayEvent.Faxed(fax.id(), fax.to(), file.toString()));
                application.answer(delivery, SmppStatus.OK);
            });
        } catch (IOException | RuntimeException e) {
            String why = e instanceof IOException ofFile ? FileErrors.describe(ofFile) : e.toString();
            thread.execute(() -> failed(fax, delivery, why, SmppStatus.TEMPORARY_APPLICATION_ERROR));
        }
    }

    private void failed(Fax fax, TextDelivery delivery, String why, int status) {
        listener.accept(new GatewayEvent.FaxFailed(fax.id(), fax.to(), why));
        application.answer(delivery, status);
    }
}
