package simrobot.control;

import java.util.Optional;
import simgsm.net.ByteLine;

/**
 * A real modem in M2's place.
 *
 * @param pin of its SIM, if known
 * @param sound 8 kHz, 16 bit, little-endian, both ways; empty if keys are only those that the modem reports
 * @param isPlayed true if SimRobot may play the calls: a sound card of the modem's would hear them
 */
public record RealModem(ByteLine address, Optional<String> pin, Optional<ByteLine> sound, boolean isPlayed) {}
