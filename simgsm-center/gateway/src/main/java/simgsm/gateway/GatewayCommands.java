package simgsm.gateway;

import simgsm.air.Msisdn;
import simgsm.console.CommandException;
import simgsm.console.CommandTable;
import simgsm.console.Console;
import simgsm.console.ConsoleCommand;

/** The console's commands. */
final class GatewayCommands implements Console.Commands {
    static final CommandTable<GatewayCommands> TABLE = new CommandTable<GatewayCommands>(
                    GatewayCommands.class.getResourceAsStream("commands.txt"))
            .add("users", (gateway, command) -> gateway.users())
            .add("drop", GatewayCommands::drop)
            .add("lock", GatewayCommands::lock);

    private final Console console;
    private final Gateway gateway;

    GatewayCommands(Console console, Gateway gateway) {
        this.console = console;
        this.gateway = gateway;
    }

    @Override
    public void perform(ConsoleCommand command) throws CommandException {
        TABLE.perform(this, command);
    }

    private void users() {
        console.emitList("users", gateway.ask(gateway::rows));
    }

    private void drop(ConsoleCommand command) throws CommandException {
        String word = command.words(1, "drop NUMBER").get(0);
        Msisdn number;
        try {
            number = Msisdn.parse(word);
        } catch (IllegalArgumentException e) {
            throw new CommandException("drop: " + e.getMessage());
        }
        if (!gateway.ask(() -> gateway.drop(number))) {
            throw new CommandException("drop: no user has the number " + number);
        }
    }

    private void lock(ConsoleCommand command) throws CommandException {
        String word = command.words(1, "lock on or lock off").get(0);
        if (!word.equals("on") && !word.equals("off")) {
            throw new CommandException("lock: expected on or off, found " + word);
        }
        gateway.ask(() -> {
            gateway.users().setLocked(word.equals("on"));
            return word;
        });
    }
}
