/** The command language, the verifier, the robot's status machine and the reply tones. */
package vericommand;
