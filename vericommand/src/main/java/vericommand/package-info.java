/**
 * The command language, the verifier, the robot's status machine and the reply tones.
 *
 * <p>Read first {@link vericommand.Instruction} (what can be ordered) and {@link vericommand.RobotStatus} with
 * {@link vericommand.StatusTable} (what is allowed when), then {@link vericommand.CommandRecognizer} (keys to orders)
 * and {@link vericommand.VeriCommand}, which joins them over the port {@link vericommand.Robot}. Everything here is a
 * core: one owner thread drives it, no clock, thread, socket or file inside.
 */
package vericommand;
