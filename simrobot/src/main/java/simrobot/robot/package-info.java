/**
 * The Pioneer 2-DX: its dimensions ({@link simrobot.robot.Pioneer2Dx}), its motion ({@link simrobot.robot.Trapezoid}),
 * direct control ({@link simrobot.robot.Drive}), its sonars ({@link simrobot.robot.SonarRing}), and the robot itself
 * ({@link simrobot.robot.SimulatedRobot}, read it first). Arrows: robot -&gt; world, robot -&gt; vericommand.
 */
package simrobot.robot;
