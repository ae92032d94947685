/**
 * The command language, the verifier, the robot's status machine and the reply tones.
 *
 * <p>Read first {@link vericommand.Instruction}, and {@link vericommand.RobotStatus} with {@link
 * vericommand.StatusRules} (the instructions permitted), then {@link vericommand.CommandGrammar} (keys to orders) and
 * {@link vericommand.VeriCommand}, which executes orders on a {@link vericommand.Robot}. The package is a core: one
 * owner thread drives it, no clock, thread, socket or file inside.
 *
 * <p>Needs only simgsm.base: the grammar and the robot's status run by the state tables of all other machines of the
 * suite.
 */
package vericommand;
