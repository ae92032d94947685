package simrobot.control;

import java.util.Optional;
import simgsm.net.LineAddress;

/** A real modem in M2's place. @param pin of its SIM, if known */
public record RealModem(LineAddress address, Optional<String> pin) {}
