package simrobot.app.batch;

import java.io.PrintStream;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.FatalError;
import simgsm.modem.client.ModemCheck;
import simgsm.modem.line.ModemLine;
import simgsm.net.LineAddress;

/** {@code --modem-check}: tries a modem and prints each command with its answer and verdict. */
public final class ModemCheckRun {
    private ModemCheckRun() {}

    /** @return exit status 0 if the modem can replace M2, else 1 */
    public static int run(LineAddress address, PrintStream out) throws InterruptedException {
        CompletableFuture<Boolean> canServe = new CompletableFuture<>();
        try (ModemLine line = new ModemLine("modem check", address, cause -> FatalError.end("simrobot", cause))) {
            line.attach(new ModemCheck(line::send, result -> print(result, out), canServe::complete));
            line.start();
            return canServe.get() ? ExitStatus.OK : ExitStatus.FAILED;
        } catch (ExecutionException e) {
            throw new IllegalStateException(e);
        }
    }

    private static void print(ModemCheck.Result result, PrintStream out) {
        out.print(Event.from(result) + "\n");
        out.flush();
    }
}
