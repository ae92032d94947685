package simgsm.gateway;

import java.io.IOException;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.UsageException;

/** Starts the gateway. */
public final class GatewayMain {
    static final String NAME = "simgsm-gateway";

    private GatewayMain() {}

    public static void main(String[] args) {
        new Program(NAME, options()).runAndExit(args, GatewayMain::run);
    }

    static Options options() {
        return Options.read(GatewayMain.class.getResourceAsStream("options.txt"))
                .commands(GatewayCommands.TABLE);
    }

    static int run(Arguments arguments) throws UsageException, IOException, InterruptedException {
        GatewaySettings settings = GatewaySettings.of(arguments);
        try (Console console = Console.onStandardOutput();
                Gateway gateway = new Gateway(settings, console::tell)) {
            Runtime.getRuntime().addShutdownHook(new Thread(gateway::close, "detach"));
            gateway.start();
            console.ready(gateway.ready());
            Program.runConsole(console, arguments, new GatewayCommands(console, gateway));
            return console.exitStatus();
        }
    }
}
